// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "core/codec/format/coefficient_priors.h"

#include <array>

namespace mocapress::runtime {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "6ACEGJNUEGHJKMPVHJJLMORVJLLMOPSWNOOPQRTXQRRRSTVZTTTUUVX]WVXYYY[`6ADFHKNVFHIJLNQVHJJLMORVKL"
    "MNOQSWNPPPQRUXRRSSTUWZVVVWWWY]XY]]]]^b8BDFHKOXFHIJLNQWIJJLMORWKLMNOQSXOOPPQRUYRSSSTUVZVVVW"
    "WXY^``_^]^^c;BEGILPZGGIJLNQWJJKLMORXKMMNOQSYPOPQQRUYUSSSTUV[ZXVWWWY^hb^^__^e@DGIKMR^HHIKLN"
    "RXKKKMNPSYLMNNOQTYQPPPQSUZWSSTTUW[]YWWWXY_k]_^^__fDFJKMQVeIJKLNPSYLKLMOQU[MMNOPRUZRPQRRSV["
    "WTTTUUX]^YYXXXZ_k[dc_``gKHMNPTYiJJKMORTYNLMNPRV]OMOPQSW[SQQRSTW^XTTUUVX^^VWWXYZ`jca^_^`hUJ"
    "QRTX_kLJKOPSWYSMOORTY_SOPPQTX_WQSSTUX_ZWUUVWY``V[YYZ[alh^cdcbh/:=?BEIVBCDFGIMTEFGHJLOVHIJK"
    "LNQWLNMNPQTXQQQRSTVZZTVVWWY^l XiZe`g6?ABDGJOCDDEGHKPFFFGIJMQGGGIIJMSIJJJKLOSMMMLMLPUKSNRPQ"
    "RT      TT7@BDFHKQDFFGHJLRGHHIKLNRHJIJKLNSKLLLMNPSONNMNOPURSQQQPSW     TRX8ADEGJMREGHIJKNS"
    "HIIJLMOSIJKLMNPTMMMNOPQUOPPOPQRVPTPRRRSWS `PTYTY9CEGIKNSFHIJKMOTHJJLMOQTJLLMNPRUMNOOPQSVPQ"
    "QQRSTWRSSSTTUYTVSVYWX]:DFHJMPVGHJKMNQVIJKLNPRVKMMNOQSWOOPPQRTWRRSSSTVYXTTUVVXZ^U[]YZZ^=DGI"
    "KNRZHIJLMORXJKLMOPSWLMNOPRTXPPQQRSUYUSSTTUWZ[WVWWXY]fZ[][]]bAFHJLOS_HJKLNPSXKLLMOQTYMNNPQR"
    "UYQQQRRTVZWTTTUVW[^XWWXXZ^k`a^_^_eGHKMORVcIKMNPRUZMMNOQRU[POPQRSV[TRSSTUW]YUVVVWX]_XYYYY[_"
    "l_`a_``e>GJH  dhJJHJ  bdKIGOPPZmJGIMQWYeT  aZWZad QXUY^ccag^Z[`dp a`bcck-0689;=?BEHKMPSUWY"
    "[^`acfihma    //579:=>ADGJMORUWY[^`befimms_   20679;=?ACFILORTWY[^`adgikoqn   4279:<>?ACFI"
    "LOQTVX[^``egimos{   ;49:<=?ACDFILORTVXZ]_]egjlotx   C7;<=?@BDFGJMORUWY[]_[fhjmpvw   O@<@@A"
    "BDFHJLNPSVXZ]_`[fijnqv|   i;PJJJHJMNPQQSUXZ]_ab`gkknpto   =@CEFHSOR]:9?BDEFHKPB=ADFGIJMRD?"
    "BFHHJKMRLFFJKKMMORUZOMOOPPQTdO QQRUSTV    PU_UWY    TViWY^      rXYdBABCEEUKOZ9<?BCCDFIM@7"
    "?CCCHGKPD:=BDDGGJPJ@EDFFHHJOQSTJJJLKLOT  RMNSNOR    SP]QRU    QUeUUX      nWW`JD?8BEWILX?8"
    "CAACDEGLCHCECCJFIOEHFCEDJEHOF@CCDEJEGNLa=LEGLFHMO  QNJRIJN    RSZNNQ     OaRQT      jSS]:@"
    "  @AWGIV  H=CACFFL> H?\?@LEGMG JDGFLEFMG  FEEMDEMDL ;@BODELJ   GHRFFK    _RXIIM      ]PNP  "
    "    fOQX     ?VGGU     @<EKL     =OADL    :=MACL    GFNEGL     MOBDK     DQEDJ    TJUEFK  "
    "    XMJM      bROV      VBDT        PH      O?BK      P:>K     GMA>K     INFDK      ODBJ  "
    "   @QBCJ      UJEK      ^RKS      U @T        @K      L  J      O  J      OJLK      L9=J  "
    "    N8HK      OFDJ      Q@BJ      ZJMR      R  Q                K  G      L  K      N  I  "
    "    N  J      M 9J      M JJ      N >J      S CPI9:<>@@BDFHJLOQTVY[^`bdgimpsw   Z>9=>C@BCC"
    "EFGILNQTVXZ^`cehlpt   ]F C5HDGIIKJFFGILNQTVY[^adhmq   ]    JJJMORRJHFFGILNQTVY]`dhm   Z   "
    " =NJMOSUOMJIGGHJLPRUX[`di   X      HMNTVQPMLKIGGHLMPSW[ae   W       RJTVSQNNMLKIHNJMOSW[` "
    "  T       JKQSSRMMMNMLKQKNMOQST                                   HACBDEDEEFGHIKLMNNNOOOOO"
    "OOOON   KF ;FIGGFGGGGHIJLMNNNOOOOOOOQ   M    IJGJIJIHGHHIKLMNNOOOOOOO   M    PJOKKLLKIIHHH"
    "JKLMNNOOOOO   M      JENLMKKJJIHHIJKLMNNOOP   M       EKLMLKKKIJIHHIJKMNNOP   M       NILM"
    "LMKKKJJJIKJJKKLMM                                                                         "
    "          L       FJ      GGIJ    HHIJL   IIJJKMO KKKKLMN LLMMMMNNLMMNNNNOMNMMNNOOKLMNNNOO"
    "L       HI      FHJK    GHHJK   HHHHILM IIIIJKM JKKKKKMNLLLLLMMNLLMMMMNNMMMMMMNOM       HJ"
    "      HHJJ    GHGJK   FGHHIKL HHHHHIL HIIIIIKNJJKKKKLMLKLLLLMNMKNMMMNOM       JK      HJJI"
    "    HHHJK   GFEIIJK FGFGHIK HGHHHHJMHHIIIIJLJJJKKKKLMMKMMLMNM       MI       NJJ     EMKJ "
    "  DHHHIKL GHIHHIK CGEGFGIKHGGHHHHKHIIHHIIKLIJJKKKML        =        IK      PKJ     OJIJK "
    "N  HEGJ JFJMJGJKGFDCHEGJIEHHGGHJGJJLHIJLL                 L       @IJ      JJKJ    O=KJ   "
    "  OIIK   JNDHJ  ?=@DFJ>GKIHHIL                                KKJLNOOOPMLMNOOWPLLKMOOONPML"
    "MOOPNINKLNONLMNLMNOPM MLKMOQL MMLMOQL MLKLNPO MMMMNOM MLLLMNL MMLMNNOPNOOMOQOLMKNNMLMLRSQR"
    "RQPQPOPNOOMOQOMNLNNMNNMQRPPQPPQPOPNOPMOQOMNLNNMMNLQRPPRPPQPOOOOPNOQNMMKNNLMNLQSQQRPPRPONPN"
    "ONPPONMLNNMNNLPRQPRPPQPOLRNNNPPPONMNNNONNPQPOPPPPPOLRNNNPPQPOONNOOOPPOOOOOPOPONQNONORPOOPM"
    "POPOQONNMMOOONOONOPPMNMMQPPPMNPRMPNLQONPNMQPQSNOSRQNMOPRMKKLPOPNMNPQ<PQRUZ`jo|:MMNQU[dq|;L"
    "MMOTZco|=MNNPTQeq|>NOOQUNfp|>QPPQUNfr|>OOORUNgo|= KOQSNhv|8GIJKL>WYdISUTUY[fq|:KLLNRJbm|?M"
    "MNPQG]^jLWWVX^bmt|BRRRTXUgt|                    9EJKOS_]e|                                "
    "                  < FGGNT_c|<GIKOU]ky|<PSV[dm|||                                        9 "
    " FHJSZj|9 GGIOU_l|9FHJNT[ir|;MOQV^ku||                              <   NPV`o|:  HIMT]g|: "
    "FHJOW`o{:GKLOV`kz|<MNOS]g|||                    =    PLdnv<   ORXa{|:  HKNU_i|; IJNR[h||>J"
    "MORYcqs|>MPPSYk|||                    ?    VLbbz<   OQXc||<  IMPWbi|> JMPW^p||@KOPS[f{{|@P"
    "QSU^izz|                    >    TM^k|=   OQXcn|=  NPT]hp|? MMQVaj{|AOQSVawxy|BRSXZgqqr{  "
    "                  >    UM_dq<   PQXdl|=  MQT^i{|@ NOR]exx|COPSXepqr|                      "
    "        <    SNgu|<   OQYft|=  ORYbyz|@ KMV^oqq|                    PVQP#                 "
    "          D?*                             NZ[ZYWVVUTSRQOMMOMJ<            MWYXWVUUTSRQONLJ"
    "KNOL            Xepjfca_]ZXWVUUSQNJF@           Y_ba_^[ZYXWVUTTRSOMIH           TS`L'     "
    "      PVQP#                                                                               "
    "                                                                                          "
    "                                                                  F'              D?*     "
    "                                                                                          "
    "                                                                                          "
    "                                                    O[[ZYWWVUTSQQONN@LOQPPMK>       QOONPP"
    "OMP@      YWOOOOPONO@     ^]WONMNQOLM     ba]WNMNLMQNO    he`]WMLLMOML    niea]VLKKKPNJ   "
    "rqjea^VLLKLMN   ssojda]VLKJGH   u|uniea]VLJIL>  t||tqog`]VKHID  {s{{smoeb^VJGGH yyyyqqnnhb"
    "]WIFH wwwwwwoolfe_VFA vvvvvvvvmjmg_XJBNWYXWVUUTSRQONLLCJOOONJNNO      NPPOONMLKJ      XUQP"
    "OPPKMF      _[VQOOOOLMG     b`[VQOOOOGI     fd`[VPNNNPMH@   hge`[VPNNLMI>   okff`[VPMNNQNI"
    "  rmjgd`]VOMMMNJ@ ||mked^[UOLLMMJ ||mqhhd_[VNJNONFzzzrzghd^[UMKMNJxxxxxxfhe`]VLFPKuuuuuuud"
    "ec_]VJIMssssssssskh`dZMBXepjfca_]ZXWVUUQ                                                  "
    "                                                                                          "
    "                                                                                          "
    "          Y_ba_^[ZYXWVUTTQ                                                                "
    "                                                                                          "
    "                                                                                      PZUQ"
    "#           SORT#           TXNP#           ZYNO$           SZTK(           MOMD8         "
    "  RTD.            JT9>            HQ'             GG/             KN>8            HR.     "
    "        '               8                                               C>-             K>"
    "1             ES5             I.              ,                                           "
    "                                                                                          "
    "                                                                          IXYYXWWVVUTSRPPO"
    "NVVUTSRSTTTUURTPQVVTSQPNNNMK    SWVVTSQOMKOLH   TZXVUSRPOMLNKO  U]YWVURRPONLMG  U_]YVUTRRO"
    "MJMM? Vc`]XVUSRROMMLL?Vec_]YVUSRQNKE= Vggb_ZXVTSQQNKC Vgjfb^[XVTSQPKH;Viikda^YWUSQPNJDVgpi"
    "kd_]YWTRPNJHWjothjc_[XVSPLH9Rb||niid_[XUTPMIMWYXWWVUTSRQPNMKBHNONQNOMQ      RKMNNMPOKJ    "
    "  VRPNNLNOMPO     [WSPNMMMPNOO    `[WSPOMLLOI     c_[WSONLMJLM    gd_ZWSONLLIPM   ifd_ZVRN"
    "MKMKH   khfd_ZURNNLJA   oqhgc^ZVRNMKHK  pmnhfb^YUQMMKIF |rnlgeb]YVQLLIFOssnnkfdb]YVPLJHNxx"
    "xmmggeaZYUPIC owwooldceaZYVUMI|||lb_[YYWVVTRQMppkgigfb^ZXWWXUQkkk`ckcck]Y[ZRYN            "
    "    Q               P^ffffffPPH     Oaiiiiii]MTF    P]ckkkkkcZLMG   P]lllllldZWMNF  RZnnnn"
    "nn[VUWMO> T^gogoogdWQUVNPFT`eppceb_`VQUVLITep`ppd`]_`USVVNTaoddood`]_cVSVPT`oodcooc]^b`WRR"
    "Wduuumfhheba`^ZRY`ca`^[ZYYWVUTTQIKTZSWK         RMQ[RT?         WVXTPNVJ        [b^^SPQN? "
    "      __bX[TPPN@      ^`gcWXVRRO=     a^[]]VUSPON@    ca]^ZYUVTPQS=   jcc^_YYUUROPN@  qicf"
    "`^^^XOPOPR@ rrrcga]_ZYOSMMM qqqidq^eZZUMRJM qqqqqbi`e[YTLSQMppppppep]`Z[UJTLuuuuuuufucda]Z"
    "VQ                71              JO,             JVTD8           SaWK)           bXLO(   "
    "        V]NO#           SMSW#           PZUQ#           TSPP'           RTMS(           V["
    "RN(           TSLH7           OKC8            |UF.            NO97                        "
    "                                                    ,               H/              Hj5   "
    "          L%              C>-             JA1             B8              K8              "
    "                                                                                IXYYXWWVVU"
    "TSRPPONVVUTSRSTTTUURTPQWVTSQPNOMMMQ   SWWVTSQOMLONK   SZXWVSSPOMMKKO  U]YWVUSRPPNMNG  U_]Y"
    "WUTSRPNLOH? Vc`]YVUTSSPNMLL>Vec_]YVUTRROLHH Vfgb_ZXVUSRQNKB Vgjfb^[XVTSQPLH9Viijda^YWUSQPO"
    "JDWgoijd_]YWTRPMKHWjothjc_[XVSPMH:Ra{{nhhd_[XUTPMJ                ISWWWVVUTTRQPOLLMRTTTTTT"
    "TSSQQQNKQTSSRQOONPOPG   SVUSSQPONLJC    TYWUTRQPNNNKB   U]ZVTSRQPOMKI>  V^]YWTSRPPOMNJ= Va"
    "`]YVTRQPPNJMI Wbd`]YVTRQONNKI?Wcic^[YUSRPNNNHEWcjfb^[XUSQPNMMEWbikfa]ZXTRQPMLLWbjkhe`[YWSQ"
    "OML@Wbnjhhd`YYWSNNLEU]psjheb_ZXWSOOM|||lb_[YYWVVTRQMppkgigfb^ZXWWXUQkkk`ckcck]Y[ZRYN      "
    "          Q               P^ffffffPPH     Oaiiiiii]MTF    P]ckkkkkcZLMG   P]lllllldZWMNF  "
    "RZnnnnnn[VUWMO> T^gogoogdWQUVNPFT`eppceb_`VQUVLITep`ppd`]_`USVVNTaoddood`]_cVSVPT`oodcooc]"
    "^b`WRRWduuumfhheba`^ZRhfb`^[YXWWVTSRQPbdcfca`_]ZXXVUVQ[bbacacarZWXVVTQVVZ[XX[aiTNVXbXNTZZ^"
    "YXVXaXSMJ  QT[^X[WWTXWTTMH  UZ`[YZUWUWSSPK TT[e`]YXWVTXSRRK TZde^[YWXXSWUNZIT]eeb^[YVVUUXT"
    "SNT]dffc][XWUXTYUPU[ddfqb`[YYWVS[QTZpehehdYYXVSWRRS^ppdgogd[XZWUTQT[_nnebee`WZVTSSTYpppphc"
    "hdaZXZUR RLN>                            LA                              OMMMMMMMMMMLLLJOM"
    "OM             OMMMMMMMMLLLKLJJJLO             NJMQPOOOONMMLLLLMLJ@            MMLNMMMMNMM"
    "LNMMLMJJI           ";

constexpr std::array<std::int16_t, 216> kWeights = {
    -1071, 812, 1090, 307, 307, 307, 307, 307,
    -206, 420, 199, -255, -48, 395, 307, 307,
    -168, 316, 44, -79, 3, 408, 307, 307,
    5, 203, 19, -57, -63, 629, 307, 307,
    53, 331, 177, -120, 39, 472, 307, 307,
    382, 299, 315, -206, -178, 527, 307, 307,
    488, 123, 358, -231, -347, 514, 307, 307,
    519, 36, 351, -47, -471, 662, 307, 307,
    686, -174, 514, -118, -402, 607, 307, 307,
    13, 324, 137, 121, 263, 307, 307, 307,
    99, 484, 278, 142, 258, 307, 307, 307,
    -35, 337, 176, 389, 192, 307, 307, 307,
    101, 322, 242, 152, 80, 307, 307, 307,
    157, 381, 190, 385, 340, 307, 307, 307,
    -10, 339, 114, 279, 151, 307, 307, 307,
    152, 325, 134, 306, 331, 307, 307, 307,
    259, 91, 293, 362, 251, 307, 307, 307,
    397, 114, 235, 99, 307, 307, 307, 307,
    187, 334, 163, 277, 242, 289, 307, 307,
    -1212, 1040, 305, 901, 307, 307, 307, 307,
    -99, 327, 178, 605, 307, 307, 307, 307,
    -325, 1072, 630, -29, 307, 307, 307, 307,
    -972, 867, 1276, 429, 307, 307, 307, 307,
    413, -201, 385, 385, 307, 307, 307, 307,
    -12, -523, 1063, 966, 307, 307, 307, 307,
    494, 212, 109, 307, 307, 307, 307, 307,
    232, 122, 307, 307, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress::runtime
