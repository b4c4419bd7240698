// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "coefficient_priors.h"

#include <array>

namespace mocapress::decoder {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "3?@CEHMTFHIJKMPUIKLMNPRVKLMMNPRWNOPPQRUXPQQRSTVYTTTTUVX[WZYYYY[`3@ADFIMUIJJKMNQVKKLMNPRVKM"
    "MNOPSWOPPPQRTXQRRSSTVZVUVVWWY][Z[[[]^b6@ADFINWIJJKMNQWKLLMNORWLMMNOPSWOPPPQRTXSRSSTTVZVVVV"
    "WWY]]][^]]^c;@CEGJOYGIJKLNQWKLLMNORWMMMNOQSXQPPQQRTYTSSSSTVZZWVWWWY^h`_[^]^dACFGJMQ]HJJKLN"
    "RWKLLMNPSXMMMNPQTXRPQQQRUYVSSTTTV[[ZWWWWY^j__^__^fGEIKMQVdHJJMNPSXKMMMOQUZOMNOPRUZSPPQRSV["
    "WTSTUUW[][WWXXZ_kaa_`__gNFLMPTYhGJKNOPTWLLMMPRV[PNNPQSV[SQQQRSW[XTSSUVX^^WXWWXZ`jb^`^`_hUJ"
    "ORTW]iFJJNRTUXHLMNQTW]TMOQQTW^VSRRSTX^ZUUUVVY``UZZYZ[`k]`beabh+89<?BGSEEFGHIMTHIIJKMOTGIIJ"
    "KMPVLMMNPPSXOPPQRSVZXSSUUVY^o`gYa`ag2<>@BEIOFFFFGHKRIJIJKLMPGHHHIKMRJJIJKLNRLMLMLLOTIOQNJP"
    "QU      RW3>?ADGJPGFGHHJMRJJJKLMOQHKJJKLOSKMLLMNPSMMLMMNPUQSPNPQRV    TPNU4?@CEHLRGHHIJKMS"
    "JKKLMNPSJKKKLNPTMNNNNOQTNNOPPPRURPRQQRSWT_PQSSRX6@BDGIMSGHIJKMOTJKLMNOQTKLLMNOQUNNOOPQSVOP"
    "PQQRTWRSSRSTUXWVZTXVW[9ACFHKOUHIJKMNQVJLLMNPRVLMMNOPSVPPPQQRTWRRRSSTUXUUUUUVWZ[ZZZZYZ^>CEG"
    "JMQYHJKLNORWJLLMOQSWNNNOPQTXQQQQRSUXTSSTTUVZZVWWWWY]e]^]][]aCDFIKOS^HKKMNPSXJLMNOQTXNNOOQR"
    "UYRQQRRTVZVTTUUUW[]XWXXXZ^j]_^]^_eJGJLNQUbKLMNPRUYMMNNPRUZPOPQQSVZTRRRSTW[XTUUVVX]_WXYYY[_"
    "ka_____e?CJK WfkFHDI Q__FLEMWM[aL@TJShYbe V_^VZ_a TRVX]cac_X_[`ctaXZ_fck(+1467:=@CGJMPRUWY"
    "[^_bcehimn    *)1357:<?BFILORTWY[^`bdfhjlnf   /+3358:<?BEILORTVY[^`adfhjoru   4-557:;=@CFI"
    "LORTVX[^_adfiknq|   <2899<=?BDGJLORTWY[^``dfilosx   F4:;<>?ADFHKMPSUWY[^`^ehilpty   Q?<?@B"
    "BDGIKLNQSVXZ]_a_fijmpuw   fJQQLMKKMNOOOSUWY[^`a[gklnpuq   BHIIIJSOS]=AGGGHIJLPAAFHHHJKMRGC"
    "HIIJKLNRNGILLLMNORVQMNPPPPRTVO TSTUSTV_  UUV_VWZ    OWiWY^      tWZeDBDDEFUKOZ@?ECDDEFIMA@"
    "DEDEGGKPE>ADEEHHJPMEEFGGIIJOPSPLHJLKLO_  NONSNOR_  LOO]QRU     UdTUY      oTV`EACABFWILXB>"
    "?CBCEDHLDJGEEEIFHN5IFFDEIFHNCDFDCEJFGNQR<EFGMGHM_  TNIRJJN_    RYNNQ     PaRQT      jUT]CH"
    "FH?AWFIV  H8@ACCGK GD?\?<JCGM  JEGGLEFMQ @KECMDELMH G4AODEL_  MEGRFFK_    PXIIL     T]QNP  "
    "    fOPX     =WGGU     >FFHI     ?O@DM    F>LBBL   @LHNEFLR    LOCEL@    DQEDKO    MUFFK  "
    "    XMJM      bUPV      VBGT        =J      P 9J      Q@5L     IM@@K@    FNHFK      OCDJ  "
    "   >Q>DJ      UIEJ      ^QMS      U >T         =      L  K      P  I      O@EK      LD>J  "
    "    NAGK      O@DJ      QDAJ      ZNLR      S  R                M  I      M  I      N  J  "
    "    N  J      M 8J      M JJ      N FJ      T FPPEFEEFEFGHIKMOQTVY[^`behjmpuw   UABBBDCCDE"
    "FGGILNQTVX[^`cehlpr   [>>?DGEFGHJJFFGILNQTVY[_adhmp   Z   <IJELMQQJHFFGILNQTVY]`dhn   Y   "
    " GQLLNSUPNKIGGHJLPRUX[`ei   X     R@NLTVQPNLKIGGHLMPSW[ad   W     H QKSVSQMNNLKIHMJMOSW]a "
    "  T       MGRSTQNNMNMMKQKNMOQST                                   GCFFGGFGGGHHIKLMNNOOOOOO"
    "OOOON   LEDFBHFFHHGHHHIJLMNNNOOOOOONO   M   INHHJJJJHHHHJKLMNOOOOOOPQ   M    QHJKMLLJJIHHI"
    "JKLMNOOOOOP   M      JIKLLLLJJHHHHJKLMNNOOO   M     J FJLLKKKKJIIHHIJKMNNOO   L       QKLL"
    "LLKKKKKJIKJJJKLMM                                                                         "
    "          L       GJ      HHJK    IHIJL   JIJJKMO KKKLLMN LLMMMMNOMMMMNNNNMNMMNNOOMMMMNNOO"
    "L       GJ      GHJJ    HHHJK   HHHHILM IIIIIJM KKKKKKMNLLLLLMMNMMMMMMNNMNMMMNNOM       HJ"
    "      HHJJ    HHIKK   GGGIIKL IGHHHIL IHIIIIKNLKKKKKLNLMLLLLMNMMLMMMNOM       GI      IKJI"
    "    FHIJK   FFHIIKK FHFHIIK HHHHHHJMIJIIIIJLJKKKKKKLJNKKMLMNL       JK      IKJE    EFMKI "
    "  JGHHJKK EIGFHJK FFCGFHJKHIJIHGHKJIJHIIIKLKJKKKKML        L       ?K       OKK     ?JJJH "
    "D >IDGJ =FKGHIJKDGFGFEGJLEDIGGHJHJHJIJJLL                 M       @JL      @HKK     NMJ   "
    "  GGJJ   NGAIK  ?AEDFJLLEHJJIL                                JKKLNOOPMMLMNOONMLKKMOOLNPNL"
    "NOPPKGMKLNOOLOMLMNOMKJMLKMONL NMLMNPK NLKLNPN NMMMNPM NLLLMNL NMMMNNOPNOOMOQOLMKNNMLMLRSQR"
    "RQPQPOPNOOMPQOMNLNNMNNMQRPPQPPQPOPNOPMPQOMMKNNMMNLQRQQRPPQPOOONPNOQNMMKNNLMNLQSQQRPPRPONPN"
    "ONPPONMLONMNNLPRQPRPPQPOLRNONPPPONMNNNONNPPPOPPPPPOLRONNPPPPOPNNNOOOOOOOOPPPPONQOONPQPOOPM"
    "POQOQOONMMOPONOONOPPNNMMQPPPMNPRMPNLQONPNMQPQSNOSRRNMOPRMKKLPOPNMNPQ7MOQTX]dm|5JJMOTYbo|7H"
    "HJMRX`m|9IJJMRQdo|:KLLMROdp|;OMMMQOfr|;IKHJPNem|B IGFJPht|6FHHGIBUXfGQQSTVWfo|8IIJKOK_k|<K"
    "KKLNHY[jLSTVW[_k{|@OOOQUUfr|                    9BHILP^]h|                                "
    "                  9 BBDKQXb|7ECHMRYdq|7MQUZak|||                                        8 "
    " DEKQZk|5 ?DGMS[hv3CEILQXbm|5JLPTZeu||                              <   GLVeg|8  FFLR[jx6 "
    "DDINT[h|5DGJNS^ez|7IIMQXaq||                    @    LManw<   IMXbn|8  FJMT^i|7 DFKQXd||8H"
    "JLOV`pp|9IKMQVbm||                    <    MM`cz<   INYcq|9  IKOU`k|9 JJNS]k{|;IJLRYdh{|;K"
    "NOSZcrz|                    ?    IM^hs<   GMWco|9  JOTZfs|9 KKNU^l{|<KNOT`gxy|=RRVYapqr|  "
    "                  @    EN^d|;   DNYbk|9  ELS_hp|9 KJP[ewx|<IJPWappq|                      "
    "        F    DOgu|C   DIXfr|>  FJWbxy|= IJR_opp|                    QURR#                 "
    "          EB&                             N]]ZYXWVUUTSQPNLMMI<            MXYYXWVUTSSQPNMK"
    "JMOO@           Xinkfca_]ZXWVUUSQNJF@           X`ca_^[ZYXWVUTTRSOMIH           VR`L'     "
    "      PUQR#                                                                               "
    "                                                                                          "
    "                                                                  C)              EB&     "
    "                                                                                          "
    "                                                                                          "
    "                                                    O]]ZYXWVUUTRQPOM=NPQONMMG       SNNNOP"
    "OH        XXONNOPOMN      ]^WONNNONJ      c`_WNLLJKTH     hfa^WMLLLPML    jmdc^WLKKKNJ    "
    "qpkeb^VLKKIPG   qspjdc^VLJJJN@  u||rifc^VKIIKH  ||tqokgc^VKHIJ  s{{{sskhe`VIGI> zzzzrroigf"
    "`WIGF yyyyyyppjifaVGA?yyyyyyyynhhgbYMFNYYYXWVUTSRQPNMLAKONONLLL       PQPOOOKLKO      YVRP"
    "OPPKLG      ^[WRPONOKKF     ba[WQOONPHJO    ee`[VQNNMPKH    iff`]VPNMLOJ=   jjgf`[VONNLQLG"
    "  mmlff_[WONNKQME voljge_[VNMLJMF u|pmjeg^[VNKNKPLs{snsihea[VMLNMLyyyylqifh_[VMILGwwwwolwh"
    "jgb]VJHLvvvvvnvvjhj`_YPHXinkfca_]ZXWVUUQ                                                  "
    "                                                                                          "
    "                                                                                          "
    "          X`ca_^[ZYXWVUTTQ                                                                "
    "                                                                                          "
    "                                                                                      PYUS"
    "#           UPSQ#           VVOS#           XZMQ#           X]SO&           OYNO,         "
    "  QVGD8           KLO/            LHC8            CN-             GGI6            KTC1    "
    "        KN.             >8              I8                              D?+             JC"
    ",             LP/             Ag8             D2                                          "
    "                                                                                          "
    "                                                                          IYZYYXWWVVUTSRPN"
    "OVUUTQPRQPSUTW[RQWWUTRPNMOL<    SXVVUTQOMMOLL   S[XVVTSPOMMLN>  T_ZWVUSSPOMMNMM Ua^YWUTRRO"
    "NKNLJ Ud`]YWUSRRPNMMK?Vgc`]YVUSRRNKLMIUgfb`]XVURQRNKJFVihea`[XVTSQQLIHUkkgda_[XVTQPOJGVlnk"
    "hd`^ZWUSPOMFVnrlieb_^ZVTRNKGThv|sigd_]YVURNJMYZYXWVUTSSQQONKAJNONOPONO      QLMNOLNPF     "
    "  VSPNNMKPPSL     [WSPOMNJLPQ     _[WSOOLLLMNJ    c`ZWSOOMMIE     gd_ZWSONLMIJ    ife^ZVRO"
    "NKLE@   khfd_ZVRNMLLF@  pohfc_ZVRNNKIB  trmgfc^YURMMKJI vsslheb^ZVQMMJF |ttpjedb]YVRKLGKzz"
    "zrrhed`^ZVPKHEyyyyqkfccb[ZVSOJ|||nc^[YYWVVTRQMxmhhhhfc_ZXWWWUQhhh_g_g__^UUZNTM            "
    "    O               OfffffffPR?     Oaiiiiii^MUE    P^kkkkkkcZLMG   P_lllllldZWMNF  Q`nnnn"
    "nn[VUWMO> SaoogoogdWQUVNPFShappceb__WQUVLITchappd`]_`USVVNTdoddood`]_cVSVPSooogaooc]^b`WRR"
    "Whuuumfhheba`^ZRXbba`^[ZYYWVUTTQHKVUPXO         SKQURO          YX^VURNJ        Ye_]SOPP? "
    "      ]bmXZRQOP?      ]cffWXUSQP=     bZ]^]VVRPON@    e^`]ZXUVTPQS=   rbc]aYYUTROPN@  qicf"
    "`_]^WOPOPR@ rrrcga]_ZYOSMMM qqqqbi_eZZUMRJM qqqqqbq_e[YTLSQMppppppeh^`Z[UJTLuuuuuuufmdda]Z"
    "VQ                =A8             JNMO8           MxTN-           ^_[O(           ^[LU%   "
    "        ZWPS#           UNUR#           PYUS#           USQO%           RSMR(           TZ"
    "OM*           UZMP-           TT@g8           UZF.            NMF+                        "
    "                                                    D2              Dg8             KO5   "
    "          KF1             D?+             JB/             MQ1             /               "
    "                                                                                IYZYYXWWVV"
    "UTSRPNOWVUTRQRQPRTUVXRQWWVTRQONPMJQ   RYWWUTQPNNPLMH  S[YWVUSPONNMME  T_ZXVUSSQPNNPKI Ua^Y"
    "WVUSSPOMNNH Ud`]YWUTRSPNNLMGVfc`]YVUTSSOLMLKUhfb`]XVUSRROLKDViheb`[XVTSRQMKHVkkgda_[XVTQPO"
    "JGVlnjhd`^ZVUSPOMFVnrlieb_]ZVTRNKGShv|sigd_]YVURNJ                HUWWWWVUTTSRQOOLMSTTSRRS"
    "SVTSPPMLQUTSRQOONNLQPJ  SXUTSQPONMJJJ   T[WUTRQPNNNNHJ  U_[WUTRPPOMNJG  Ua^[WTSRPONMLME Vc"
    "b^ZVTSQPONKOJ?Vee`^ZVTRQONMIHJVfgd`]ZVSRQNNNGDVflec_]YUSRPNKLEWgmidb_[YTSQOMNKVflolca^[XTR"
    "QNLJVdtokfaa]ZYSQPLDTburllhb_[YWTPOM|||nc^[YYWVVTRQMxmhhhhfc_ZXWWWUQhhh_g_g__^UUZNTM      "
    "          O               OfffffffPR?     Oaiiiiii^MUE    P^kkkkkkcZLMG   P_lllllldZWMNF  "
    "Q`nnnnnn[VUWMO> SaoogoogdWQUVNPFShappceb__WQUVLITchappd`]_`USVVNTdoddood`]_cVSVPSooogaooc]"
    "^b`WRRWhuuumfhheba`^ZRieb`^[YXWWVTSRQPbfdfdb__^ZWXVUUQY^^`a`ibbWYVYWXQTYW[VWV[gRMM    S]]^"
    "YXWZbYRML  OUZ_X[XVTXVTSMH  TZdYY[VWUWSTRK TT]e`]YYWUTXSQSK T[ee^ZYVXXSWUNZIT[jdb^[YVVUUXT"
    "SNT`ifib][XWUXTYUPU[ibfqb`[YYWVS[QS_pehehdYYXVSWRRT]hpdgogd[XZWUTQS]ennebee`WZVTSSSZhppphc"
    "hdaZXZUR QLNC                            IF                              OMMMMMMMMMMLLLKLM"
    "MM             OMMMMMMMMLLLKKJIIOOO            OONONOOOONMMLLLLMLJ@            MNMMMMMMNMM"
    "LNMMLMJJI           ";

constexpr std::array<std::int16_t, 216> kWeights = {
    -848, 592, 1178, 307, 307, 307, 307, 307,
    -18, 249, 193, -222, -81, 292, 307, 307,
    320, 15, 45, -92, -75, 297, 307, 307,
    377, 13, 41, -92, -168, 620, 307, 307,
    347, 27, 367, -95, -98, 473, 307, 307,
    412, 148, 426, -295, -294, 525, 307, 307,
    393, 37, 418, -223, -401, 567, 307, 307,
    475, -7, 542, -69, -623, 608, 307, 307,
    1057, -210, 638, 113, -666, 320, 307, 307,
    45, 342, 254, 132, 294, 307, 307, 307,
    67, 507, 214, 185, 346, 307, 307, 307,
    -17, 287, 181, 379, 264, 307, 307, 307,
    -4, 354, 296, 206, 145, 307, 307, 307,
    135, 292, 231, 384, 284, 307, 307, 307,
    -33, 214, 218, 344, 225, 307, 307, 307,
    17, 216, 158, 437, 304, 307, 307, 307,
    251, 84, 351, 473, 303, 307, 307, 307,
    362, 242, 214, 67, 307, 307, 307, 307,
    257, 412, 290, 403, 231, 129, 307, 307,
    -812, 799, 26, 1066, 307, 307, 307, 307,
    -193, 356, 275, 425, 307, 307, 307, 307,
    -242, 975, 567, 12, 307, 307, 307, 307,
    -1039, 873, 1260, 509, 307, 307, 307, 307,
    405, -210, 386, 386, 307, 307, 307, 307,
    20, -491, 1022, 967, 307, 307, 307, 307,
    381, 158, 176, 307, 307, 307, 307, 307,
    216, 239, 307, 307, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress::decoder
