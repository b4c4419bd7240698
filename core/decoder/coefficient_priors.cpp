// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "coefficient_priors.h"

#include <array>

namespace mocapress::decoder {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "5@CEGJMTEGHJKMPUHJJLMOQVJLLNOPSWNOOPQRTXPQQRSTVYSTTUUVX[WWYYXY[`5ACFHJMUGHIJLNPVJJKLMOQVKM"
    "MNOPSWNOOPQRTXQRRSSTVZUUVVWWY]WZ]][^^b6ADFHJNWGHIJLMPVJJKLMOQWLMMNOPSXOOPPQRTYRRRSSTVZUVVV"
    "WWY^`^[^^]^c:AEFHKOYGHIJKMQVKJKLMORWLMMNOPSXPOPPQRTYTSSSSTVZYVWWWWY^h_^^]^^e@CGHJMQ]HIJKLN"
    "QWMKLMNPSYMMNNOQTYQPPQRSUZVSSTTUW[]YWWWXY^j_`]_^^fFFJKMPUdIJKLNPSXNLMMOQU[NNNOPRU[RQQQRSV["
    "WTTSUUW]^YWWXXZ_kcb_`__gMGMNPSYiKJKMOQTYPMMNPRV^PNOPQSV[TPQRRTW]YSSTUVX^^WYXWXZ`ib^a__`hWI"
    "QRTX_kMKMOQTVXUONOQTX`UPPPRTX_VRRSTUX_ZSUVVVY`_WZZZZ[`k`g`d`bh-:=?ADHSBCDFGILSFFGHJKNUHIIK"
    "LNPVLLMNOPSXQQPQRSVYYTTUVWY^l`bYb``g3>ABDFIODDEFGHJPGFGHIJLPHIGIIJLRIJIJJLNRNNLKLLOTNQONPP"
    "RV     HUU4?BDFHKOEEFGHJLQHHHIKLMQHJIJKLNRKKKLMMOSMMLMNNPTOPOPOPRV    OSQX6ACEGILQEFGHJKMR"
    "HIIKLMORJJKLMNPSLMMNNOQTNONOOPRUPRPPQRRWPQbVUUTY7BDFHJNRFGHJKMOSIJJKMNPTJLLMNOQUMNNOPQSUOQ"
    "PPQRTWRQRSSTUXSVSVWVX[9CEGILOUGHJKLNQUJKKLNORVLMMNOQSVOOPPQRTWRRRSSTUXVTTUUVWZ^Y]YZYZ^=DGI"
    "KMQZHIJKMORWKKLMNPSWMMNOPQTXPPPQRSUYTSSSTUVZ[VVVWWY]f[][][]a@EHJLOR^HIKLNPSXLLLMOQTYNNOOPR"
    "UYQQQRRSVZVSTTUUW[]WWWXXY^k^^^^__eHHKLNQUbKLMNOQUZOMNOPRUZPOPQRSV[SRRSSTW[YTUVVVX]^YYYYYZ_"
    "kca`__`e<FHIM dfIDMH  bgLHBJWQZmIGONXZZfX V [XZ_a TTSX[cd_hZZ]`cq Z]abdk+.468:<?ADGJMPRUWY"
    "[^`bcfhjkf    ,-2679<>@CFILORTWY[^`bdfilmkc   /,357:<>@CFILOQTVY[^`adfikops   4.468;<?ACFI"
    "KNQTVX[^`adgilnr|   <267:<>@BDGILORTVY[]__egilos{   E57:;=?ADFHJMORUWY[^`^ehilpt|   O=A==@"
    "BDFIKMNPSVXZ]_a_eijlpvv   m OMILJJMOQRRSUXZ]_accgjknosr   @CFGHITOR]:<CDEFGIKPD@DGFGJKMRGB"
    "FHHIKLNRNFJKLLMNORTQPMOOPPRTTO PSSUSTV    QT_VWY    TciWY^      sWYdCACCEEUKOZ?;ACCDEFIMA;"
    "DECDHGKPD>?DEEGGJPJ@EFGGIHJOPaOJGJLKLO   OONSNOR    XN]QRU    QPeTUY      oUW`GB>B@DWILX=B"
    "@C@CECHKBBFEDEJFIOFEBDDEJEHNH@FBCEJEGNLa;HFFLGHM    LJRJJN    RSYNNQ     QaSQT      jTT]E "
    " F::XGIV   9CACDFK? H><?KDGMF  9CFLEGME JIFBMCEMFL G@BODEL    8FRFFK    _PXIIL      ]PNP  "
    "    fOQX      WGHU     ?;LMK     <PBDL    =AM>CM    FHOCFL     KOCDL     DQEDK    TIUFFK  "
    "    XNIM      bTOV      V@ET       @;L      P?8K      P<AL     LM<?L     NNFDK      OCCJ  "
    "    QAEJ      UIDJ      ^NLS      U 6T         G      L  K      O  K      O FK      MEAJ  "
    "    NAFK      OFDJ      QDBJ      ZJLR      S  R                J  L      M  J      N  J  "
    "    N  J      M :J      M KJ      N ?J      T BPL9<>@BBDEGIKMOQTVY[^`begimptv   Z?>=@CABCD"
    "FFGILNQTVXZ^`cehlpt   ]?\?D@ICGIIKJFFGILNQTVY[_adhmr   ]    NPHNORRJHFFGILNQTVY]`dhm   Z   "
    " <QJMOTUONJIGGHJLPRUX[`ei   X     R?MOTVQPMLKIGGHLMPSW[ae   W     M QJTVSQNNMLKIHMJMOSW]a "
    "  T       LIRSSRNMMMMMKRKNMOQST                                   HCDCDDEEFGGHIKLMNNNOOOOO"
    "OOOPM   LM?EEEFGGGGGGHIKLMNNNOOOOOOOM   M    KGHJHJIHGHHIKLMNNOOOOOON   M    OHMLNLLJJIHHI"
    "JKLMNNOOOOO   M      HILMLKKJJHHHHJKLMNNOON   M       GKLMKKKJJIIHHIJKMNNOO   M       NLLL"
    "LLLJKJJIIKJJKKLMM                                                                         "
    "          L       GJ      GHJK    HHIJL   IIJJKMN KKKLLMN LMMMMMNOMMMNNNNOLMMNNNOOLLMMNNOO"
    "L       GI      GHJK    GHHJK   HHHHIKM IIIIIKM JKKKKLMNKLLLMMMNLMMMMNNNLMMMNNNOM       GK"
    "      GIJJ    GHHKK   GGHHIKL HHHHHIL HHIIIIKNKKJKKKLMLLLLLMMNJMLMMMNOM       CK      HCJH"
    "    GHIJK   FFFIIKK FHGHHIK IHHHHHJMIIIIIIJLJKLKKKKLMMKLLLMNL       IL       FJK    EEPKI "
    "  ILIIIKJ EJFIHIK ?GFEGGJKHGHHGGHKGIHJHIIKLMJKKKKML        K        I       PLJ     @KJII "
    "F >HFFJ  FNGHHJKLFCGGEGJNJFIGGHJKMFIIJJLL                 K       JIK      =KKH     IOJ   "
    "  FFIJ   JOBIK  ?<BEFJHJLGHJIL                                LJJLNOOORNLMNOOSNLKKMOOQLKLL"
    "NOPQNINKLNORNLNLMNONMRNLKMOOM MMLMOPL MLKLNON NMMMNOM MLLLMML MMLMNNOPNOOMOQOLMKNNMLMLRSQR"
    "RQPQPOPNOOMOQOMNLNNMNNMQRPPQPPQPOPNOOMOQOMMLNNMNNLQRPPRPPQPOOOOPNOQNMMKNNLMNLQSQQRPPRPONPN"
    "ONPPONMLNNMNNLPRQPRPPQPOLRNNNPPPONMNNNONNPQPOPPPPPOLRNNNPPPPOOMNOOOPPOOOOOPOPONQOONOQPOOPM"
    "POPOQOONMMOOONOONOPPMNMLQPPPMNPRMPNLQONPNMQPQSNOSRQNMOPRMKKLPOPNMNPQ9OPRUY^fp|7KKMQUZbm|7J"
    "JLOSXal|9KKLOTQcn|:LMLPUNdp|;NMNQVNeq|:QMORUMfl|: JNRTNfs|5GIIKM=UYeGRQTVZ^fm|7JIKNRJ_j|<K"
    "LMORG][cKUUUX^bhu|?QPQTXUfq|                    8CGJMR^[i|                                "
    "                  8 ECFLSZd|8HGJNTZfy|:ORU[djx||                                        6 "
    " HGJQYev5 CDINT]h|4EFIMRZbr|7KLPU]fu||                              9   ORU^h|5  FIMRZg{4 "
    "EEIOU]g|6DHKNT^hz|9JKMRYcs||                    <    ULlmw:   NSW`m|7  IJMT]g|7 GHLRXdt|9G"
    "JLQX`pp|;KLNRYdv||                    =    ULcdz:   PSYal|7  KLOV^mz9 KHOT[l{|;JKMSYhs{|=M"
    "NOU^izz|                    <    VL_kv:   ORXbk|8  MPT[fs|: ILOW^r{|=LMOUbwxy|@PQVWnpqr{  "
    "                  =    UM_c|:   PSYdi|8  NQT^fp|; MPT^jwy|>QNQ[eopq|                      "
    "        ;    VNfu|9   PRYdp|8  NRWbxy|: JNW`opp|                    QVRQ#                 "
    "          EA'                             N[[ZYXWVUTTRQONLNLI<            MXYXXWVUTSSQPOMK"
    "JMOO@           Xglkfca_]ZXWVUUSQNJF@           Y`ba_^[ZYXWVUTTRSOMIH           VR_L'     "
    "      PVRR#                                                                               "
    "                                                                                          "
    "                                                                  C)              EA'     "
    "                                                                                          "
    "                                                                                          "
    "                                                    O][ZYXWVUTSRQPON>NPQPPNJG       SNOMOQ"
    "PNO@      YWONONPONN      ^^VONNNPOJT     b`^WOMMJLVI     hf`]WNMMLPNL    njdb]WMKLLNMO   "
    "tnkea]VMKLLNI   qvqieb]VMJKKK   |u|njf`]VLIJMF  ||ttolha]VLHKJ@ s{{{spnhb^VJGJF zzzzqqlkic"
    "^WJGG@xxxxxxpxkic_VHB?xxxxxxxxmjifaXMENXYYXWVUTSRQPNMLBKNOONLOK@      OPPOPONKPL      XVRP"
    "NPPJK=      ^]VQPONPLMG     b`[VQOOOPHKM    ee`[VPONMQLG    hge`[VPNNLNJ=   llfe`[VPNNLRMI"
    "  tmkge_]VONNLPL= |qmkfd_[VNMLKNI ||qnhfg_[VNJNMOI{{{snihd`ZVMKONLyyyyynheg^]VMHOJwwwwwwig"
    "ge`[VKGMvvvvvvvmjhj_`ZPHXglkfca_]ZXWVUUQ                                                  "
    "                                                                                          "
    "                                                                                          "
    "          Y`ba_^[ZYXWVUTTQ                                                                "
    "                                                                                          "
    "                                                                                      PYVR"
    "#           SPTQ#           UVOR#           YZNR#           X]TP$           N_PL,         "
    "  SWGC8           MLM/            MN?7            FP)             GGF8            KRE1    "
    "        IP.             >8              I8                              D?+             JB"
    "-             IN1             ?g8             C4                                          "
    "                                                                                          "
    "                                                                          IYZYXXWVVUTSRQPO"
    "NVUUTRRSTTUTUOXQQVVTSRPNMPKNO   RXVVTSQOMLOLF   SZXVVSSPOLLOM?  T^YWVUSRPONMMJJ U_]YWUURRO"
    "NJNPI Vc_]YWUTRRPNMLL>Vec_[YVUTRRNLJKIVgfa_ZXVUSQRNKGEVhifa^ZXVTTQPMH8Vikhd`^ZXVTQPPKFVomh"
    "id_]YWURQONGWinnigb^]XVTQNJFSdr|uhgd_]XVTRNJMXYYXWVUTSSQQONLAJNOOPQOOK      QLNNNMOSKT    "
    "  VSPNOLMQOQL     [VSPOMLMNQOO    _[WSOOMKLOQO    c`ZWSOOLLLJQ    gd_ZWSONLLJQO   hgd_ZVRO"
    "NKKJL   khfd_ZVRNMLJD   qnhgc^ZVRNNKG;  pomhfc_YURMMKJL rrrlhfb^YVRLNID |slnmedc]YVQKLHNrz"
    "zrrgeea]YVPKHEyqyyljgdce[YVTOJ|||lc^[YXWVVTRQMmxihhgec_ZXXWWVQjjbbjjja^ZWTTTRP            "
    "    M               QYffffffPR?     P^iiiiii^MUE    P]kkkkkkcZLMG   P[lllllldZWMNF  Q_nnnn"
    "nn[VUWMO> S`gogoogdWQUVNPFT`appceb__WQUVLIUceappd`]_`USVVNTgoddood`]_cVSVPTboogaooc]^b`WRR"
    "Wmmuumfhheba`^ZRXaba`^]ZYYWVUTTQIKXWQTL         SHOT            VX_STSOG        Z`a^RPOS> "
    "      a_bYZTPNP?      `_gcXWVRQP=     b[[^]VVSPON@    ab_]YZUUTPQS=   rg`]aYYUTROPN@  qffd"
    "`_]^WOPOPR@ rrjega]_ZYOSMMM qqqidf`eZZUMRJM qqqqqbq_e[YTLSQMppppppeh^`Z[UJTLuuuuuuufucda]Z"
    "VQ                =A8             KOMM8           NzSK-           `aWP%           ]ZKS'   "
    "        WWNS#           SNUS#           PYVR#           SSRN&           STOP(           VZ"
    "SP'           SXOP-           QUDg8           ZYF-            OOD+                        "
    "                                                    C4              Bg8             GO8   "
    "          KF0             D?+             J@1             JM2             ,               "
    "                                                                                IYZYXXWVVU"
    "TSRQPONWVUTSRSSTUTUOVQQWWUTRQONPKPTVTJRXWWUSRPNMPLI   SZXWVTSPONMNLF  T^YXVVSSQPONOIG U_]Y"
    "WVUSRPOLOOG Vc_]YWUTRSQOOLMDVeb_[YVUTRROLKLJVhfa_ZXVUSQROLHCViifa^ZXVUTQQMI7Vijhd`^ZXVTQPP"
    "KFVomhic_]YWUSQONGWinnigb^]XVTQNJGScr|uhgd_]XVTRNJ                ITXWWWVUUTSRQPMJMSTTTSTT"
    "TTTSROPPPTTSRRPPNNOQO>  RWUTSRQOONLKF   SZWUTRRQONNNJ>  U]ZWUTRQPONNKG  U_]ZVTSRQPOMNNH Va"
    "`]ZVTSQPPNMNJFVcc_]YVTRQPNNLJFWffc_[YUSRQONNJEWdieb][XUSRPOMNGWfikda]ZXTSQPMNKWdjnic`]ZWSR"
    "POMJWctmigc_ZXXRPPLGV_lpmjfb_[YWTOOM|||lc^[YXWVVTRQMmxihhgec_ZXXWWVQjjbbjjja^ZWTTTRP      "
    "          M               QYffffffPR?     P^iiiiii^MUE    P]kkkkkkcZLMG   P[lllllldZWMNF  "
    "Q_nnnnnn[VUWMO> S`gogoogdWQUVNPFT`appceb__WQUVLIUceappd`]_`USVVNTgoddood`]_cVSVPTboogaooc]"
    "^b`WRRWmmuumfhheba`^ZRgha`^[YXWWVTSRQPaeeedb`^^ZWXVUVQ]__`babg^YWYUVWRTVYYVWX`hWOSaaLOUX^]"
    "[WVXbXRKO  OT]^Y[WWUXVTVKH  T[dYZZVWUXSSPK TUYca[YYWVTXSRRK T[de][YVWXSWUNZIT[jdb^[YVVUUXT"
    "SNT]fifc][XWUXTYUPU]bdfqb`[YYWVS[QTYpehehdYYXVSWRRT[ppdgogd[XZWUTQS^`nnebee`WZVTSSS[pppphc"
    "hdaZXZUR QLNC                            JF                              OMMMMMMLMMMLLLJMM"
    "NM             OMMMMMMMLLLLKKJIIOOO            OKMPOONOONMMLLLLMLJ@            NMLNMMMMNMM"
    "LNMMLMJJI           ";

constexpr std::array<std::int16_t, 216> kWeights = {
    -1233, 853, 1134, 307, 307, 307, 307, 307,
    -139, 385, 228, -322, -27, 273, 307, 307,
    -96, 318, 104, -98, 50, 349, 307, 307,
    74, 249, -79, 80, -74, 558, 307, 307,
    209, 225, 220, -58, -107, 546, 307, 307,
    322, 279, 337, -173, -243, 619, 307, 307,
    423, 148, 370, -126, -365, 612, 307, 307,
    376, -32, 542, -23, -533, 682, 307, 307,
    519, -149, 513, -265, -417, 614, 307, 307,
    37, 326, 72, 165, 294, 307, 307, 307,
    112, 513, 134, 166, 234, 307, 307, 307,
    -45, 370, 179, 355, 291, 307, 307, 307,
    56, 369, 272, 269, 132, 307, 307, 307,
    133, 409, 159, 352, 322, 307, 307, 307,
    -83, 275, 164, 334, 220, 307, 307, 307,
    129, 347, 83, 372, 367, 307, 307, 307,
    173, 84, 285, 441, 313, 307, 307, 307,
    361, 91, 153, 199, 307, 307, 307, 307,
    163, 457, 64, 252, 249, 183, 307, 307,
    -845, 753, 85, 990, 307, 307, 307, 307,
    -179, 371, 206, 458, 307, 307, 307, 307,
    -327, 1043, 663, -15, 307, 307, 307, 307,
    -1011, 849, 1302, 481, 307, 307, 307, 307,
    421, -186, 373, 373, 307, 307, 307, 307,
    6, -508, 1061, 962, 307, 307, 307, 307,
    375, 252, 91, 307, 307, 307, 307, 307,
    52, 218, 307, 307, 307, 307, 307, 307,
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
